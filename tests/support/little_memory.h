#pragma once
#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>

namespace test {

// While it lives this process can take so many bytes more than it has taken, of addresses, as a machine with little
// memory: what is larger cannot be allocated. A sanitizer reserves terabytes of them, and ends the program.
class LittleMemory {
public:
    explicit LittleMemory(std::size_t more) {
        getrlimit(RLIMIT_AS, &m_before);
        std::size_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const rlimit less{pages * std::size_t(sysconf(_SC_PAGESIZE)) + more, m_before.rlim_max};
        setrlimit(RLIMIT_AS, &less);
    }
    ~LittleMemory() { setrlimit(RLIMIT_AS, &m_before); }
    LittleMemory(const LittleMemory&) = delete;
    LittleMemory& operator=(const LittleMemory&) = delete;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    static constexpr bool kWorks = false;
#else
    static constexpr bool kWorks = true;
#endif

private:
    rlimit m_before{};
};

}  // namespace test
