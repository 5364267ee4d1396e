#pragma once
// What the detail canvas keeps beside its planes, as a part of a slot: the notes of its tiles and
// blocks (core/detail/store/detail_checkpoint.h) and what its lock counted.

#include "core/detail/lock/lock.h"
#include "core/detail/store/detail_checkpoint.h"
#include "formats/checkpoint/archive.h"

namespace pentimento::checkpoint {

struct DetailNotes {
  DetailCheckpoint checkpoint;
  LockStatistics lock;
};

void put_detail(const DetailNotes& notes, ArchiveWriter& to);
/// If the notes are not those of a canvas with this layout, the reader has the problem.
DetailNotes take_detail(const DetailLayout& layout, int layers, int channels, ArchiveReader& from);

}  // namespace pentimento::checkpoint
