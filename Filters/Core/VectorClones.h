/**
 * @file VectorClones.h
 * @brief Loops that use the vector instructions of the machine they run on, in one binary.
 */
#ifndef isthmus_VectorClones_h
#define isthmus_VectorClones_h

/**
 * Placed before a function: compiles it for AVX-512, AVX2 and the baseline; the version is chosen
 * when the library is loaded. Useful only for long loops of double arithmetic. Results may differ
 * in the last bit from machine to machine, not from run to run.
 *
 * With other compilers than GCC 12 on x86-64 Linux, and with sanitizers (which start after the
 * choice is made), the macro is empty and the function is compiled once.
 */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) &&   \
  !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#if __GNUC__ >= 12
#define ISTHMUS_VECTOR_CLONES                                                                      \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#endif
#endif
#ifndef ISTHMUS_VECTOR_CLONES
#define ISTHMUS_VECTOR_CLONES
#endif

#endif
