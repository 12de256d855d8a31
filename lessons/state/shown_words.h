#pragma once
#include <array>
#include <optional>
#include <string_view>

// The words for what views show, in files, in the order of the enumerators that they stand for.
namespace lessons {

inline constexpr std::array<std::string_view, 9> kOverlayNames{
    "edges", "edge_functions", "verdict", "fragments", "polygon_size", "depth_test", "strange", "violators", "classes"};

inline constexpr std::array<std::string_view, 6> kSpaceNames{"world", "eye", "clip", "screen", "light", "point"};
inline constexpr std::array<std::string_view, 6> kFaceNames{"+x", "-x", "+y", "-y", "+z", "-z"};

// "eye", "light 0", "light 0 -x".
struct SpaceWords {
    std::size_t space = 0;  // of kSpaceNames
    int light = 0;
    int face = -1;  // of kFaceNames; -1: none is named
};
std::optional<SpaceWords> parseSpace(std::string_view words);
inline constexpr char kSpaceExpected[] = "world, eye, clip, screen, light 0, light 0 -x or point";

// An option of a 3D view; a switch is 0 or 1.
struct SpaceOption {
    std::string_view name;
    double min = 0, max = 1;
};
inline constexpr std::array<SpaceOption, 23> kSpaceOptions{{{"normals", 0, 2},
                                                            {"normal_length", 4, 400},
                                                            {"every_normal", 1, 100000},
                                                            {"vector_length", 4, 400},
                                                            {"vectors"},
                                                            {"lights"},
                                                            {"eye"},
                                                            {"faces"},
                                                            {"boxes"},
                                                            {"spheres"},
                                                            {"frustum"},
                                                            {"projection"},
                                                            {"reflection"},
                                                            {"normal_colors"},
                                                            {"lobe"},
                                                            {"handles"},
                                                            {"object_tool", 0, 2},
                                                            {"light_frusta"},
                                                            {"vector_n"},
                                                            {"vector_l"},
                                                            {"vector_v"},
                                                            {"vector_r"},
                                                            {"vector_h"}}};

}  // namespace lessons
