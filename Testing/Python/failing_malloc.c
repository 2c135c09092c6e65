/* Preloaded by FailingAllocations.py: the n-th allocation of at least a number of bytes fails, once. One that
   VTK's contour filter, its list of arrays or the loader asks for is left to them, and the next one fails
   instead: these end the process, and nobody can catch that. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <stddef.h>
#include <string.h>

extern void* __libc_malloc(size_t size);
extern void* __libc_calloc(size_t count, size_t size);
extern void* __libc_realloc(void* memory, size_t size);
extern void* __libc_memalign(size_t alignment, size_t size);

static size_t least = 0; /* 0: nothing is counted */
static long left = 0;
static long seen = 0;

/* From now on, allocation number `number` (from 1; 0: none) of at least `bytes` fails. */
void failing_malloc_arm(size_t bytes, long number)
{
  void* frame;
  backtrace(&frame, 1); /* loads what it needs now */
  seen = 0;
  left = number;
  __atomic_store_n(&least, bytes, __ATOMIC_SEQ_CST);
}

/* How many there were since. */
long failing_malloc_disarm(void)
{
  __atomic_store_n(&least, 0, __ATOMIC_SEQ_CST);
  return seen;
}

/* Whether the innermost callers, up to the first of Isthmus' libraries, are ones that end the process. */
static int is_left(void)
{
  static const char* const names[] = { "FlyingEdges", "AllocateArrays", "__tls_get_addr" };
  void* frames[24];
  const int count = backtrace(frames, 24);
  for (int i = 0; i < count; ++i)
  {
    Dl_info info;
    if (!dladdr(frames[i], &info))
    {
      continue;
    }
    if (info.dli_fname && strstr(info.dli_fname, "vtkIsthmus"))
    {
      return 0;
    }
    for (int k = 0; info.dli_sname && k < 3; ++k)
    {
      if (strstr(info.dli_sname, names[k]))
      {
        return 1;
      }
    }
  }
  return 0;
}

static int fails(size_t size)
{
  const size_t bound = __atomic_load_n(&least, __ATOMIC_RELAXED);
  if (bound == 0 || size < bound)
  {
    return 0;
  }
  const long number = __atomic_add_fetch(&seen, 1, __ATOMIC_SEQ_CST);
  if (left == 0 || number < left)
  {
    return 0;
  }
  const size_t before = least;
  const long wanted = left;
  left = 0; /* what follows may allocate */
  if (is_left())
  {
    least = before;
    left = wanted;
    return 0;
  }
  errno = ENOMEM;
  return 1;
}

void* malloc(size_t size)
{
  return fails(size) ? NULL : __libc_malloc(size);
}

void* calloc(size_t count, size_t size)
{
  return fails(count * size) ? NULL : __libc_calloc(count, size);
}

void* realloc(void* memory, size_t size)
{
  return fails(size) ? NULL : __libc_realloc(memory, size);
}

void* memalign(size_t alignment, size_t size)
{
  return fails(size) ? NULL : __libc_memalign(alignment, size);
}

void* aligned_alloc(size_t alignment, size_t size)
{
  return fails(size) ? NULL : __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, size_t alignment, size_t size)
{
  if (fails(size))
  {
    return ENOMEM;
  }
  *memory = __libc_memalign(alignment, size);
  return *memory ? 0 : ENOMEM;
}
