#include "pipeline/formats/object_names.h"

#include <map>
#include <set>

namespace pipeline {

void tellApart(std::vector<Object>& objects) {
    std::set<std::string> taken;
    std::map<std::string, int> uses;
    for (Object& object : objects) {
        const std::string stem = object.name;
        while (!taken.insert(object.name).second) object.name = stem + ' ' + std::to_string(++uses[stem] + 1);
    }
}

}  // namespace pipeline
