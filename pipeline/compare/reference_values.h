#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "pipeline/compare/handed_in/values.h"
#include "pipeline/run/frame.h"

// What a comparison reads of a frame.
namespace pipeline::foreign {

// Per pixel whether a polygon is seen there; empty where the frame does not say.
std::vector<std::uint8_t> coveredIn(const Frame& frame);

// The values of one buffer of a frame; nothing where it has none.
std::optional<Values> valuesIn(const Frame& frame, const BufferName& name);
std::optional<Values> valuesIn(const Frame& frame, const BufferName& name, const std::vector<std::uint8_t>& covered);

// The compared buffers of a frame by their names. Each is read when somebody first asks for it: all of them are as much
// memory as the frame itself, and most are never asked for. May be read by several threads; copies share what was read.
class ReferenceValues {
public:
    ReferenceValues() = default;
    ReferenceValues(FramePtr frame, std::vector<std::uint8_t> covered, const BufferSet& wanted);

    bool contains(const std::string& name) const;
    const Values* find(const std::string& name) const;  // null where there is none
    const Values& at(const std::string& name) const;    // of one that is there
    // Gives the memory of a buffer's values back; who asks again has them read anew. Nobody may hold them.
    void forget(const std::string& name) const;
    const std::map<std::string, BufferName>& names() const { return m_names; }

private:
    struct Read {
        std::mutex mutex;
        std::map<std::string, Values> values;
    };
    FramePtr m_frame;
    std::vector<std::uint8_t> m_covered;
    std::map<std::string, BufferName> m_names;
    std::shared_ptr<Read> m_read = std::make_shared<Read>();
};

}  // namespace pipeline::foreign
