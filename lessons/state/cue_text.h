#pragma once
#include <string>
#include <string_view>

#include "lessons/state/cue_list.h"

namespace lessons {

// The list as TOML that still has what someone has written into its file by hand: comments, blank lines, the order of the
// keys and what is left out. text: the file, from which `before` was read. Cues that have not changed stay as they were
// written; in the others the changed keys alone are written anew. Comments stay where they stand, those of a removed cue
// go with it. readCues gives `list` again.
std::string cueText(const CueList& list, std::string_view text, const CueList& before);

}  // namespace lessons
