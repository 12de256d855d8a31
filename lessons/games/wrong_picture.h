#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/core/result.h"
#include "pipeline/core/stop.h"
#include "pipeline/defects/defect_table.h"
#include "pipeline/run/frame.h"

namespace lessons {

// The game of the wrong picture: somebody looks at a frame with a planted defect, marks the first stage that leaves
// something wrong, and names the cause. Level B of three: without the right picture beside. No window and no terminal is
// known here; both play it through this.

// What can be marked: 0 is the file, 1 to 6 are the stages in their order.
inline constexpr int kBoxes = 1 + int(pipeline::kStageCount);
std::string_view boxLabel(int box);  // "The file", "Cull"
int boxOf(const pipeline::DefectRow& row);
std::optional<int> findBox(std::string_view name);  // "file", "z-buffer", "5"

// A defect to be found: by a seed and a number, the same on every machine.
struct Riddle {
    pipeline::Defect defect = pipeline::Defect::None;
    std::shared_ptr<const pipeline::Scene> right;  // without it
    std::array<pipeline::Defect, 5> causes{};      // to choose from: mostly of one stage
    int par = 0;                                   // looks that are free
};
// boxes: what may be wrong; empty: anything. number: from 0; as many riddles in a row differ as there are defects. An error
// where no defect of the game is of these boxes, or its scene cannot be read.
pipeline::Result<Riddle> makeRiddle(std::uint64_t seed, std::size_t number, const std::vector<int>& boxes = {});
std::size_t riddleCount(const std::vector<int>& boxes = {});
// A scene and a defect that somebody has chosen; the other causes by the seed.
Riddle ownRiddle(std::shared_ptr<const pipeline::Scene> right, pipeline::Defect defect, std::uint64_t seed);

// The scene in which a defect shows, as its row says. An error where it cannot be read.
pipeline::Result<pipeline::Scene> sceneOf(const pipeline::DefectRow& row);

class WrongPicture {
public:
    enum class Phase : std::uint8_t { Stage, Cause, Over };

    // Null when stopped while the frames are computed.
    static std::unique_ptr<WrongPicture> begin(Riddle riddle, const pipeline::Stop& stop = {});

    const Riddle& riddle() const { return m_riddle; }
    const pipeline::DefectRow& row() const { return defectInfo(m_riddle.defect); }
    const pipeline::FramePtr& wrong() const { return m_wrong; }
    const pipeline::FramePtr& right() const { return m_right; }  // for the end
    Phase phase() const { return m_phase; }

    // Counted the first time; the picture is free. What is seen, as text.
    std::string look(const pipeline::BufferName& buffer);
    std::string look(glm::ivec2 pixel);  // in the picture
    const std::vector<std::string>& looks() const { return m_looks; }

    // In Phase::Stage. Why is said of a stage that is accused wrongly: what its own run on what it got gives.
    struct Answer {
        bool isRight = false;
        std::string why;  // several lines
    };
    Answer mark(int box);
    bool isCleared(int box) const { return m_cleared[std::size_t(box)]; }
    // In Phase::Cause, of the riddle's causes.
    Answer name(std::size_t cause);
    bool isExcluded(std::size_t cause) const { return m_excluded[cause]; }

    // The next, or empty where all have been given.
    std::string hint();
    int hints() const { return m_hints; }

    // 100, less 5 for each look beyond par, 20 for each wrong stage, 10 for each hint, 20 for each wrong cause; at least 10.
    int points() const;
    // Both values where it shows first, both equations of the pixel that differs most, and how it is mended.
    std::string reveal() const;

private:
    WrongPicture() = default;
    void countLook(std::string what);

    Riddle m_riddle;
    pipeline::FramePtr m_right, m_wrong;
    Phase m_phase = Phase::Stage;
    std::vector<std::string> m_looks;
    std::array<bool, kBoxes> m_cleared{};
    std::array<bool, 5> m_excluded{};
    int m_wrongStages = 0, m_wrongCauses = 0, m_hints = 0;
};

// The pixel whose colour differs most between two frames of one size, the first of equals; nothing where none does.
std::optional<glm::ivec2> worstPixel(const pipeline::Frame& a, const pipeline::Frame& b);

}  // namespace lessons
