/**
 * @file AddressSpaceLimit.h
 * @brief Leaves the process little memory, for tests of what happens then.
 */
#ifndef isthmus_AddressSpaceLimit_h
#define isthmus_AddressSpaceLimit_h

#include <fstream>

#include <sys/resource.h>
#include <unistd.h>

namespace isthmus::testing
{

/// While it lives, the process may allocate only this much more (ulimit -v).
class AddressSpaceLimit
{
public:
  explicit AddressSpaceLimit(std::size_t mebibytes)
  {
    getrlimit(RLIMIT_AS, &this->Before);
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit limit = this->Before;
    limit.rlim_cur =
      pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (rlim_t{ mebibytes } << 20);
    setrlimit(RLIMIT_AS, &limit);
  }
  ~AddressSpaceLimit() { setrlimit(RLIMIT_AS, &this->Before); }
  AddressSpaceLimit(const AddressSpaceLimit&) = delete;
  AddressSpaceLimit& operator=(const AddressSpaceLimit&) = delete;

private:
  rlimit Before{};
};

}

#endif
