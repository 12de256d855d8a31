#include "app/frames/other_source.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "app/frames/equation_symbols.h"
#include "app/frames/stage_buffer.h"
#include "app/look/shown_name.h"
#include "app/look/text.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_reader.h"
#include "pipeline/plan/memory_limit.h"

namespace app {

using pipeline::BufferInfo;
using pipeline::BufferName;
using pipeline::Domain;
using pipeline::Scene;
using pipeline::Setting;
using pipeline::SettingGroup;
using pipeline::SettingKind;
using pipeline::SettingRef;
using SourceKind = OtherSource::Kind;

namespace {

// Another camera or light makes another picture, not another way to the same one.
bool choosesPipeline(const Setting& setting) {
    const bool here = setting.group == SettingGroup::Picture || setting.group == SettingGroup::Shading ||
                      setting.group == SettingGroup::Depth || setting.group == SettingGroup::Shadow;
    return here && (setting.kind == SettingKind::Choice || setting.kind == SettingKind::Switch);
}

// The ref that a scene with other lights or objects has by the same key.
bool hasSetting(const Scene& scene, const SettingRef& ref) {
    return ref.setting && ref.index < ref.setting->count(scene);
}

OtherSource withSetting(const SettingRef& ref, double value) {
    return {.kind = SourceKind::Setting, .setting = ref, .value = value};
}

QString whyNotSetting(const Scene& scene, const SettingRef& ref, double value) {
    Scene other = scene;
    ref.set(other, value);
    const pipeline::Errors errors = checkSceneAndMemory(other);
    return errors.empty() ? QString() : toQString(format(errors.front()));
}

// In words: what a file's word means to somebody who does not see the setting's name.
QString choiceCaption(const SettingRef& setting, const QString& word, const Scene& scene) {
    constexpr std::array<std::array<std::string_view, 3>, 5> kCaptions{{{"numerics.power", "log1p", "exp(n log1p(−q))"},
                                                                        {"numerics.power", "pow", "(R·V)ⁿ"},
                                                                        {"shadow.bias", "automatic", "Automatic bias"},
                                                                        {"shadow.bias", "constant", "Constant bias"},
                                                                        {"shadow.bias", "slope", "Bias by slope"}}};
    const std::string key = setting.key(), said = word.toStdString();
    if (key == "shadow.bias" && said == "constant" && scene.settings.shadowBiasValue == 0)
        return QStringLiteral("No bias");
    for (const auto& [ofKey, ofWord, caption] : kCaptions)
        if (key == ofKey && said == ofWord) return toQString(caption);
    if (said == "on" || said == "off" || said == "none") return labelOf(setting) + ": " + word;
    if (word.startsWith("fixed")) return word.mid(5) + " bits";
    QString words = word;
    if (key.starts_with("numerics.")) words.replace('-', ' ');
    return words.left(1).toUpper() + words.mid(1);
}

bool haveSameShape(const BufferInfo& a, const BufferInfo& b) {
    return a.domain == b.domain && a.channels == b.channels;
}

}  // namespace

QString nameOf(const OtherSource& source) {
    switch (source.kind) {
        case SourceKind::Buffer: return toQString(source.buffer.text());
        case SourceKind::PreviousStage: return "previous stage";
        case SourceKind::Before: return "before the last change";
        case SourceKind::Setting: {
            const auto text = toQString(formatSetting(source.setting, source.value));
            return QString("%1 (%2)").arg(text, toQString(source.setting.setting->label).toLower());
        }
        case SourceKind::Scene: {
            const auto scene = pipeline::builtInScene(source.scene.toStdString());
            return scene ? toQString(scene->title) : source.scene;
        }
        case SourceKind::File: return shownName(source.file);
        case SourceKind::Mine: return "my renderer";
    }
    return {};
}

QString captionOf(const SettingRef& setting, const Scene& scene) {
    const auto text = toQString(formatSetting(setting, setting.get(scene)));
    if (setting.setting->kind == SettingKind::Choice) return choiceCaption(setting, text, scene);
    const QString label = labelOf(setting), symbol = symbolOf(setting);
    const bool hasSymbol = symbol != label || symbol.size() == 1 || symbol.contains('_');
    return hasSymbol ? symbol + " = " + text : label + ' ' + text;
}

std::string keyOf(const OtherSource& source) {
    switch (source.kind) {
        case SourceKind::Buffer: return "buffer " + source.buffer.text();
        case SourceKind::PreviousStage: return "previous stage";
        case SourceKind::Before: return "before";
        case SourceKind::Setting:
            return "setting " + source.setting.key() + '=' + formatSetting(source.setting, source.value);
        case SourceKind::Scene: return "scene " + source.scene.toStdString();
        case SourceKind::File: return "file " + source.file.toStdString();
        case SourceKind::Mine: break;  // its folder is no part of a state
    }
    return {};
}

pipeline::Result<OtherSource> sourceNamed(std::string_view key, const Scene& scene) {
    if (key == "before") return OtherSource{.kind = SourceKind::Before};
    if (key == "previous stage") return OtherSource{.kind = SourceKind::PreviousStage};
    const auto rest = [&](std::string_view word) -> std::optional<std::string> {
        if (!key.starts_with(word)) return {};
        return std::string(key.substr(word.size()));
    };
    if (const auto file = rest("file "))
        return OtherSource{.kind = SourceKind::File, .file = QString::fromStdString(*file)};
    if (const auto words = rest("buffer "))
        if (const auto name = pipeline::findAnyBuffer(*words))
            return OtherSource{.kind = SourceKind::Buffer, .buffer = *name};
    if (const auto words = rest("scene "))
        if (pipeline::builtInScene(*words))
            return OtherSource{.kind = SourceKind::Scene, .scene = QString::fromStdString(*words)};
    if (const auto words = rest("setting ")) {
        const auto equals = words->find('=');
        const auto setting = findSetting(scene, words->substr(0, equals));
        if (!setting) return setting.errors();
        const auto value = parseSetting(*setting, equals == words->npos ? "" : words->substr(equals + 1));
        if (!value) return value.errors();
        return withSetting(*setting, *value);
    }
    return pipeline::Error{{},
                           "there is nothing called \"" + std::string(key) + "\" to compare with",
                           "before, previous stage, buffer NAME, setting KEY=VALUE, scene NAME or file FILE"};
}

std::optional<BufferName> otherBuffer(const OtherSource& source, const BufferName& shown, const Scene& scene) {
    switch (source.kind) {
        case SourceKind::Buffer: return source.buffer;
        case SourceKind::Before:
        case SourceKind::Setting:
        case SourceKind::Scene: return shown;
        case SourceKind::File:
        case SourceKind::Mine: return std::nullopt;
        case SourceKind::PreviousStage: break;
    }
    // What stands on texels is another picture: the stage before it is taken.
    for (std::size_t i = index(pipeline::bufferInfo(shown.id).stage); i-- > 0;) {
        const BufferName before = mainBuffer(pipeline::kStages[i], scene);
        if (pipeline::bufferInfo(before.id).domain != Domain::Texel) return before;
    }
    return std::nullopt;
}

ScenePtr otherScene(const OtherSource& source, const ScenePtr& scene, const ScenePtr& before) {
    switch (source.kind) {
        case SourceKind::Buffer:
        case SourceKind::PreviousStage: return scene;
        case SourceKind::Before: return before;
        case SourceKind::File:
        case SourceKind::Mine: return nullptr;
        case SourceKind::Scene: {
            const auto builtIn = pipeline::builtInScene(source.scene.toStdString());
            auto read = builtIn ? pipeline::readScene(builtIn->file) : pipeline::Result<Scene>(pipeline::Errors());
            if (!read || !checkSceneAndMemory(*read).empty()) return nullptr;
            return std::make_shared<Scene>(std::move(read).value());
        }
        case SourceKind::Setting: break;
    }
    if (!hasSetting(*scene, source.setting)) return nullptr;
    auto other = std::make_shared<Scene>(*scene);
    source.setting.set(*other, source.value);
    if (!checkSceneAndMemory(*other).empty()) return nullptr;
    return other;
}

const ScenePtr& OtherScene::of(const OtherSource& source, const ScenePtr& scene, const ScenePtr& before) {
    if (m_source == source && m_scene == scene && m_before == before) return m_other;
    m_source = source, m_scene = scene, m_before = before;
    const ScenePtr last = std::exchange(m_other, otherScene(source, scene, before));
    if (!m_other || !last || source.kind != SourceKind::Setting) return m_other;
    auto other = std::make_shared<Scene>(*m_other);
    for (std::size_t i = 0; i < std::min(other->objects.size(), last->objects.size()); ++i) {
        pipeline::Object& object = other->objects[i];
        if (object.shape && object.shape == last->objects[i].shape) object.mesh = last->objects[i].mesh;
    }
    return m_other = other;
}

std::vector<OtherChoice> otherChoices(const pipeline::Frame& frame, const BufferName& shown, bool hasBefore,
                                      const lessons::DerivedRecipe& recipe) {
    const Scene& scene = frame.scene();
    std::vector<OtherChoice> choices;
    choices.push_back({{}, "Before the last change", {.kind = SourceKind::Before}});
    if (!hasBefore) choices.back().whyNot = "Nothing has been changed yet.";
    choices.push_back({{}, "The previous stage", {.kind = SourceKind::PreviousStage}});
    if (!otherBuffer(choices.back().source, shown, scene)) choices.back().whyNot = "This is the first stage.";

    const auto precision = findSetting(scene, "precision");
    const auto isDouble = precision && precision->get(scene) == double(pipeline::Precision::Double);
    if (precision)
        choices.push_back({{}, "In double precision", withSetting(*precision, double(pipeline::Precision::Double))});
    if (isDouble) choices.back().whyNot = "The scene runs in double already.";

    for (const BufferName& name : pipeline::allBuffers(scene.lights.size())) {
        if (name == shown || !haveSameShape(bufferInfo(name.id), bufferInfo(shown.id))) continue;
        choices.push_back({"Another buffer", toQString(name.text()), {.kind = SourceKind::Buffer, .buffer = name}});
    }
    for (const BufferName& name : pipeline::allDerived(scene.lights.size())) {
        if (name == shown || !haveSameShape(bufferInfo(name.id), bufferInfo(shown.id))) continue;
        const auto buffers = buffersFor(name, recipe, scene);
        choices.push_back({"Another buffer",
                           toQString(name.text()),
                           {.kind = SourceKind::Buffer, .buffer = name},
                           buffers ? QString() : toQString(buffers.errors().front().found)});
    }
    for (const SettingRef& ref : settingsOf(scene)) {
        const Setting& setting = *ref.setting;
        if (!choosesPipeline(setting) || !setting.idle(scene).empty()) continue;
        for (std::size_t i = 0; i < setting.choices.size(); ++i) {
            const auto value = double(i);
            if (value == ref.get(scene)) continue;
            choices.push_back({"Another pipeline/" + toQString(setting.label), toQString(setting.choices[i]),
                               withSetting(ref, value), whyNotSetting(scene, ref, value)});
        }
    }
    return choices;
}

}  // namespace app
