#pragma once
// Edits of a state dump that a fuzzer chooses: values, attributes, shapes, types, layouts, links.

#include <hdf5.h>

#include <string>
#include <vector>

#include "tests/fuzz/choices.h"

namespace pentimento::test {

class DumpEditor {
 public:
  /// Of an open file that may be written. `choices` outlives the editor.
  DumpEditor(hid_t file, Choices& choices);

  /// Makes one change, or none where the choice does not fit.
  void edit();

 private:
  void set_value();
  void set_attribute();
  void remove();
  void replace_dataset();
  void link_elsewhere();
  void move();
  void remove_attribute();

  const std::string& some_dataset() { return choices_.of(datasets_); }
  double some_number();
  hid_t some_type();

  hid_t file_;
  Choices& choices_;
  std::vector<std::string> datasets_, groups_;
};

}  // namespace pentimento::test
