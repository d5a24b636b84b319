# The kernels are the same source compiled once per instruction set; each object exports one table, in a namespace of its
# own. Nothing but the table may be shared between them (tests/engine checks the symbols).
# -Wmaybe-uninitialized: GCC 12 warns of its own AVX-512 headers (its bug 105593).
set(KERNEL_FLAGS -O3 -fno-math-errno -fno-trapping-math -ffp-contract=fast -Wno-maybe-uninitialized)
if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(KERNEL_FLAGS -ffp-contract=fast -Wno-maybe-uninitialized)
endif()
if(GONIO_SANITIZE)
  # Fully inlined packets multiply what a sanitizer adds: minutes a file. Memory and races are checked through calls, without
  # debug information; undefined behaviour of scalars is checked everywhere else.
  list(APPEND KERNEL_FLAGS -O1 -g0 -fno-sanitize=undefined)
  if(GONIO_SANITIZE MATCHES "address")
    list(APPEND KERNEL_FLAGS --param asan-instrumentation-with-call-threshold=0)
  endif()
endif()
set(FLAGS_baseline)
set(FLAGS_avx2 -mavx2 -mfma)
set(FLAGS_avx512 -mavx512f -mavx512dq -mavx512vl -mavx512bw -mavx2 -mfma)

# gonio_per_isa(TARGET ISA SOURCE): the source as an object library for one instruction set.
function(gonio_per_isa target isa source)
  add_library(${target} OBJECT ${source})
  target_compile_definitions(${target} PRIVATE GONIO_ISA=${isa} GONIO_ISA_${isa}=1)
  target_compile_options(${target} PRIVATE ${KERNEL_FLAGS} ${FLAGS_${isa}})
  target_link_libraries(${target} PRIVATE gonio_models gonio_options)
endfunction()
