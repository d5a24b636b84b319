// What another library guarantees about the order of events, said to the thread sanitizer.
//
// The sanitizer follows mutexes and atomics where it instruments them. gRPC's libraries are built
// without it: what one thread hands to another through them looks like a race. Each use of these
// states one guarantee of that library, no more; elsewhere they are nothing. Thread safety: any
// thread.
#pragma once

#ifdef GONIO_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace gonio {

// All that this thread did so far happens before what follows a happens_after() of the same
// address. The address is only a name: nothing is read there.
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
