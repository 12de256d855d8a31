#include "tests/architecture/source_tree.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace fs = std::filesystem;

namespace architecture {
namespace {

// The patterns of .gitignore as this project writes them: "/name/" at the root, "name/" and
// "*.ending" anywhere, "/name*/" by the name's beginning.
class Ignored {
public:
    explicit Ignored(const fs::path& root) {
        std::ifstream file(root / ".gitignore");
        for (std::string line; std::getline(file, line);) {
            if (!line.empty() && line[0] != '#') m_patterns.push_back(line);
        }
    }
    bool operator()(const std::string& name, bool atRoot) const {
        return name == ".git" || std::ranges::any_of(m_patterns, [&](std::string pattern) {
                   if (pattern.starts_with('/')) {
                       if (!atRoot) return false;
                       pattern.erase(0, 1);
                   }
                   if (pattern.ends_with('/')) pattern.pop_back();
                   if (pattern.starts_with('*')) return name.ends_with(pattern.substr(1));
                   if (pattern.ends_with('*')) return name.starts_with(pattern.substr(0, pattern.size() - 1));
                   return name == pattern;
               });
    }

private:
    std::vector<std::string> m_patterns;
};

bool isText(const std::string& content) { return content.find('\0') == std::string::npos; }

SourceFile read(const fs::path& root, const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string content((std::istreambuf_iterator<char>(stream)), {});
    SourceFile result{fs::relative(file, root).generic_string(), {}};
    if (!isText(content)) return result;
    std::istringstream text(content);
    for (std::string line; std::getline(text, line);) result.lines.push_back(line);
    return result;
}

}  // namespace

SourceTree readSourceTree(const std::string& root) {
    const Ignored ignored(root);
    SourceTree tree;
    for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator(); ++entry) {
        if (ignored(entry->path().filename().string(), entry.depth() == 0)) {
            entry.disable_recursion_pending();
        } else if (entry->is_regular_file()) {
            SourceFile file = read(root, entry->path());
            if (!file.lines.empty()) tree.push_back(std::move(file));
        }
    }
    std::ranges::sort(tree, {}, &SourceFile::path);
    return tree;
}

std::vector<std::string> topLevel(const std::string& root) {
    const Ignored ignored(root);
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(root)) {
        const std::string name = entry.path().filename().string();
        if (!ignored(name, true)) names.push_back(name);
    }
    std::ranges::sort(names);
    return names;
}

}  // namespace architecture
