#pragma once
#include <string_view>

#include "pipeline/core/result.h"
#include "pipeline/scene/scene.h"

namespace web {

// A scene of any format; the files that it names are those of the page.
pipeline::Result<pipeline::Scene> sceneFromText(std::string_view name, std::string_view text);

}  // namespace web
