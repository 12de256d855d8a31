#pragma once

// The page's: told how far long work is. what: `size` bytes of UTF-8, as "known errors"; done of all.
extern "C" __attribute__((import_module("shadescope"), import_name("progress"))) void tellProgress(const char* what,
                                                                                                   int size, int done,
                                                                                                   int all);
