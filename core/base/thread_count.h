#pragma once
// How many threads a job asks for. The machine may give fewer (Threads::count()).

namespace pentimento {

/// `count`, or, where that is 0, as many as the machine has cores.
int wanted_threads(int count);

}  // namespace pentimento
