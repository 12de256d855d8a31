#include "app/cli/out_of_memory.h"

#include <dlfcn.h>
#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "app/cli/cli.h"
#include "pipeline/core/memory.h"
#include "pipeline/export/folder/hidden_folders.h"

namespace app {

namespace {

std::atomic<bool> mayThrow{false}, hasThrown{false}, endsWithoutThreads{false};

int say(std::string_view sentence) {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, sentence.data(), sentence.size());
    return kCouldNotWrite;
}

// Several threads may fail at once: the first says so and ends the program, the others wait for that.
[[noreturn]] void end(int (*say)() = sayOutOfMemory) {
    static std::atomic_flag isEnding;
    thread_local bool endsHere = false;  // and what it does for that fails too
    while (!endsHere && isEnding.test_and_set()) ::pause();
    endsHere = true;
    pipeline::removeHiddenFolders();
    ::_exit(say());
}

// What a message and the way to it need.
constexpr std::size_t kLittle = std::size_t{64} << 10;

// operator new calls this again, from the same place, where the memory that was freed did not help.
void handleFailure() {
    thread_local const void* triedFrom = nullptr;
    const void* const from = __builtin_frame_address(0);
    if (triedFrom != from) {
        triedFrom = from;
        pipeline::giveBackFreedMemory();
        return;
    }
    triedFrom = nullptr;
    if (!mayThrow) end();
    void* volatile little = std::malloc(kLittle);  // volatile: else the compiler takes malloc and free away
    if (!little) end();
    std::free(little);
    hasThrown = true;
    throw std::bad_alloc();
}

// The standard library and TBB throw these where the system gives no further thread; TBB names only the call.
bool isForWantOfAThread(const std::runtime_error& error) {
    const auto* const system = dynamic_cast<const std::system_error*>(&error);
    return (system && system->code() == std::errc::resource_unavailable_try_again) ||
           std::string_view(error.what()).starts_with("pthread_create");
}

// Where nothing can catch what was thrown, as in a thread of a library. Where a function of a library is noexcept, as
// those of std::filesystem with an error_code are, GCC does not say what was thrown.
[[noreturn]] void handleUncaught() {
    const std::exception_ptr thrown = std::current_exception();
    if (!thrown && hasThrown) end();
    if (thrown) {
        try {
            std::rethrow_exception(thrown);
        } catch (const std::bad_alloc&) {
            end();
        } catch (const std::runtime_error& error) {
            if (isForWantOfAThread(error)) end(sayOutOfThreads);
        } catch (...) {
        }
    }
    std::abort();
}

void handleSignal(int) { ::_exit(sayOutOfMemory()); }
void handleExit() {
    if (!mayThrow) ::_exit(sayOutOfMemory());
}

// What a library raises that does not look at what malloc gives it, or looks and gives up.
constexpr int kSignalsOfStart[]{SIGABRT, SIGSEGV, SIGTRAP};  // the last by GLib

}  // namespace

void endWhenOutOfMemory() {
    endsWithoutThreads = true;
    std::set_new_handler(handleFailure);
    std::set_terminate(handleUncaught);
    std::atexit(handleExit);
#ifndef __SANITIZE_ADDRESS__  // which has handlers of its own
    for (const int signal : kSignalsOfStart) std::signal(signal, handleSignal);
#endif
}

void throwWhenOutOfMemory() {
    mayThrow = true;
#ifndef __SANITIZE_ADDRESS__
    for (const int signal : kSignalsOfStart) std::signal(signal, SIG_DFL);
#endif
}

bool hasThrownOutOfMemory() { return hasThrown; }

void onlyThrowWhenOutOfMemory() {
    endsWithoutThreads = false;
    std::set_new_handler(nullptr);
}

int sayOutOfMemory() {
    return say("shadescope: not enough memory; a smaller picture (--size) and fewer buffers (--buffers) need less\n");
}

int sayOutOfThreads() {
    return say("shadescope: the system gives no further thread; its limit on processes or memory is reached\n");
}

int sayLibraryFailed() {
    return say("shadescope: a library that draws text or 3D views failed, as some do where memory has run out\n");
}

}  // namespace app

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which have one of their own
// The loader gives it to every library in place of the C library's.
extern "C" [[gnu::visibility("default")]] int pthread_create(pthread_t* thread, const pthread_attr_t* how,
                                                             void* (*run)(void*), void* with) noexcept {
    using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
    static const auto next = reinterpret_cast<Create>(::dlsym(RTLD_NEXT, "pthread_create"));
    const int error = next(thread, how, run, with);
    if (error == EAGAIN && app::endsWithoutThreads) app::end(app::sayOutOfThreads);
    return error;
}
#endif
