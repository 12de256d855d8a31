#pragma once
#include <map>
#include <string>

namespace web {

// What the writers of files have written, by path: a page has no disk.
std::map<std::string, std::string, std::less<>>& writtenFiles();

}  // namespace web
