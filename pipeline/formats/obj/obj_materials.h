#pragma once
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/formats/model_formats.h"
#include "pipeline/formats/obj/mtl_reader.h"
#include "pipeline/formats/text/tally.h"

namespace pipeline {

// The material files of an OBJ file. A file that is not there or is wrong costs its materials, never the geometry.
class ObjMaterials {
public:
    ObjMaterials(const SourceText& obj, const FileLoader& load, Errors& errors)
        : m_obj(obj), m_load(load), m_errors(errors) {}

    // What stands behind an mtllib of this line: one name with spaces, or several names without. Errors: where reading
    // was given up.
    void load(std::string_view names, int line);

    // Null where no file has one of this name. Where none has the same letters, another case of them is found, and what
    // stands before a comment.
    const Material* find(std::string_view name) const;
    // Whether a file that was named could not be read.
    bool someMissing() const { return m_missing.count > 0; }
    std::vector<Remark> remarks() const;

private:
    struct Said {
        Remark first;
        std::size_t count = 0;
        void add(std::string about, std::string text) {
            if (count++ == 0) first = {std::move(about), std::move(text)};
        }
    };

    const Material* findWritten(std::string_view name) const;
    bool loadOne(const std::string& name, int line, std::string& whyNot);
    bool open(const std::string& name, const std::string& written, int line, std::string& whyNot);

    const SourceText& m_obj;
    const FileLoader& m_load;
    Errors& m_errors;
    std::vector<NamedMaterial> m_materials;
    std::map<std::string, std::size_t, std::less<>> m_of, m_ofLowerCase;  // by name
    std::map<std::string, std::string, std::less<>> m_tried;              // by name, why it cannot be read; or empty
    std::set<std::string, std::less<>> m_read;                            // paths
    Said m_missing, m_otherNames;
    MtlTallies m_tallies;
};

}  // namespace pipeline
