#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace pipeline {

// The six stages, in the order of the specification.
enum class StageId : std::uint8_t { Transform, Cull, Normals, ShadowBuffer, ZBuffer, Shading };
inline constexpr std::size_t kStageCount = 6;
inline constexpr std::array<StageId, kStageCount> kStages{StageId::Transform,    StageId::Cull,    StageId::Normals,
                                                          StageId::ShadowBuffer, StageId::ZBuffer, StageId::Shading};

constexpr std::size_t index(StageId stage) { return static_cast<std::size_t>(stage); }

struct StageInfo {
    StageId id;
    std::string_view name;     // "z-buffer": for --until, lessons, the manifest
    std::string_view label;    // "Z-buffer": for the window
    std::string_view summary;  // what it does, one sentence
    std::string_view takes, leaves;
};

const StageInfo& stageInfo(StageId stage);
std::optional<StageId> findStage(std::string_view name);

}  // namespace pipeline
