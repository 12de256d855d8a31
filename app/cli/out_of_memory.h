#pragma once
#include <new>

namespace app {

// Until throwWhenOutOfMemory: an allocation that fails writes one fixed sentence to standard error and ends the program
// with status 4. For the time before main, in which nothing has been done yet and nobody could catch an exception. So
// does a library that aborts, crashes or ends the program while it starts: libraries of the window do so when malloc
// fails.
void endWhenOutOfMemory();

// For the beginning of main: what is too large throws std::bad_alloc, which main and the jobs of the window answer with a message.
// Where not even a little is to be had the way to a message would need what is not there, and the program ends as
// above. Hidden folders that it leaves are removed by the next run into theirs.
void throwWhenOutOfMemory();

// Whether std::bad_alloc has been thrown since: what a library then says of a file need not be true, for streams take a
// number that they have no memory for as one that is none.
bool hasThrownOutOfMemory();

// Between endWhenOutOfMemory and onlyThrowWhenOutOfMemory a thread that the system refuses ends the program at once, with
// its sentence and status 4, whoever asked for it: some libraries wait for ever for a thread that never began.

// For a window, which frees what a job had and goes on: every failure throws.
void onlyThrowWhenOutOfMemory();

// The answer to std::bad_alloc at the end of main: says so without needing any memory. Gives the program's exit status.
int sayOutOfMemory();

// The same where the system gives no further thread: a limit on processes, or no memory for a stack.
int sayOutOfThreads();

// The same of a library that crashed or hung while it drew.
int sayLibraryFailed();

// What has been said already, with the file that it concerns.
struct OutOfMemorySaid : std::bad_alloc {};

}  // namespace app
