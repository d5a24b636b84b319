// Loops on several threads. Thread safety: no state.
#pragma once

#include <cstddef>
#include <functional>

namespace gonio::render {

// Calls body(0) ... body(count - 1), each once, on up to `threads` threads (0: one a processor).
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}  // namespace gonio::render
