// Preloaded into the program by tests/cli: ends it by force, or lets it run out of memory, where the environment says.
//   SHADESCOPE_TEST_KILL_AT=N        ends it before its N-th change of a folder, counted from 1: rename, unlink, mkdir
//   SHADESCOPE_TEST_FAIL_AT=N        its N-th allocation fails; with SHADESCOPE_TEST_FAIL_TIMES=M so do the next, M in all
//   SHADESCOPE_TEST_FAIL_FROM=N      its N-th allocation fails, and so do all after it
//   SHADESCOPE_TEST_NO_THREAD_FROM=N its N-th thread cannot be started, and neither can any after it
//   SHADESCOPE_TEST_ABORT=1          aborts before main, as a library that cannot begin
//   SHADESCOPE_TEST_COUNTS=FILE      writes how many changes and allocations there were
// Counts in all threads together; nothing here allocates.
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

std::atomic<long> changes{0}, allocations{0}, threads{0};

// The environment is not there yet where the loader allocates; then nothing is counted.
struct Wanted {
    bool isRead = false;
    long killAt = 0, failAt = 0, failTimes = 1, failFrom = 0, noThreadFrom = 0;
};
Wanted wanted;

bool isReady() {
    if (wanted.isRead || !environ) return wanted.isRead;
    const auto read = [](const char* name) {
        const char* value = std::getenv(name);
        return value ? std::atol(value) : 0;
    };
    wanted.killAt = read("SHADESCOPE_TEST_KILL_AT");
    wanted.failAt = read("SHADESCOPE_TEST_FAIL_AT");
    wanted.failTimes = std::max(1L, read("SHADESCOPE_TEST_FAIL_TIMES"));
    wanted.failFrom = read("SHADESCOPE_TEST_FAIL_FROM");
    wanted.noThreadFrom = read("SHADESCOPE_TEST_NO_THREAD_FROM");
    return wanted.isRead = true;
}

__attribute__((constructor)) void abortAtStart() {
    if (std::getenv("SHADESCOPE_TEST_ABORT")) std::abort();
}

__attribute__((destructor)) void tellCounts() {
    const char* file = std::getenv("SHADESCOPE_TEST_COUNTS");
    if (!file) return;
    const int out = ::open(file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    char text[64];
    const int size = std::snprintf(text, sizeof text, "%ld %ld\n", changes.load(), allocations.load());
    if (out >= 0 && ::write(out, text, std::size_t(size)) != size) ::_exit(99);
}

void beforeChange() {
    if (isReady() && ++changes == wanted.killAt) ::kill(::getpid(), SIGKILL);
}

bool fails() {
    if (!isReady()) return false;
    const long n = ++allocations;
    return (n >= wanted.failAt && n < wanted.failAt + wanted.failTimes && wanted.failAt > 0) ||
           (wanted.failFrom > 0 && n >= wanted.failFrom);
}

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

void* none() {
    errno = ENOMEM;
    return nullptr;
}

}  // namespace

extern "C" {

int rename(const char* from, const char* to) noexcept {
    beforeChange();
    return next<int (*)(const char*, const char*)>("rename")(from, to);
}
int unlink(const char* file) noexcept {
    beforeChange();
    return next<int (*)(const char*)>("unlink")(file);
}
int remove(const char* file) noexcept {
    beforeChange();
    return next<int (*)(const char*)>("remove")(file);
}
int unlinkat(int folder, const char* file, int flags) noexcept {
    beforeChange();
    return next<int (*)(int, const char*, int)>("unlinkat")(folder, file, flags);
}
int rmdir(const char* folder) noexcept {
    beforeChange();
    return next<int (*)(const char*)>("rmdir")(folder);
}
int mkdir(const char* folder, mode_t mode) noexcept {
    beforeChange();
    return next<int (*)(const char*, mode_t)>("mkdir")(folder, mode);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* how, void* (*run)(void*), void* with) noexcept {
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    if (isReady() && ++threads >= wanted.noThreadFrom && wanted.noThreadFrom > 0) return EAGAIN;
    return next<Create>("pthread_create")(thread, how, run, with);
}

void* malloc(std::size_t size) noexcept { return fails() ? none() : __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) noexcept { return fails() ? none() : __libc_calloc(count, size); }
void* realloc(void* at, std::size_t size) noexcept { return fails() ? none() : __libc_realloc(at, size); }
void* memalign(std::size_t to, std::size_t size) noexcept { return fails() ? none() : __libc_memalign(to, size); }
void* aligned_alloc(std::size_t to, std::size_t size) noexcept { return memalign(to, size); }
int posix_memalign(void** at, std::size_t to, std::size_t size) noexcept {
    void* const got = memalign(to, size);
    if (got) *at = got;
    return got ? 0 : ENOMEM;
}
}
