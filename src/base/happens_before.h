// Annotations for the thread sanitizer: the order of events that another library guarantees.
//
// The sanitizer follows mutexes and atomics where it instruments them. gRPC's libraries are built
// without it, so that data handed from one thread to another through them looks like a race. Each
// annotation states one guarantee of that library. In other builds the functions are empty. Thread
// safety: any thread.
#pragma once

#ifdef GONIO_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace gonio {

// Everything that this thread has done so far happens before what follows a happens_after() of the
// same address. The address serves as a name and is not read.
inline void happens_before([[maybe_unused]] const void* address) {
#ifdef GONIO_THREAD_SANITIZER
  __tsan_release(const_cast<void*>(address));
#endif
}

inline void happens_after([[maybe_unused]] const void* address) {
#ifdef GONIO_THREAD_SANITIZER
  __tsan_acquire(const_cast<void*>(address));
#endif
}

}  // namespace gonio
