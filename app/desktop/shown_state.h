#pragma once
#include <QObject>
#include <filesystem>

#include "app/document/document.h"
#include "lessons/state/window_state.h"

namespace app {

class ErrorList;
class ViewArea;
class WindowLayout;

// The window's state as a value: its scene, its place in the frame, and how every view looks. Sessions, cues and texts
// keep it.
class ShownState : public QObject {
    Q_OBJECT
public:
    ShownState(Document& document, ViewArea& views, const WindowLayout& layout, ErrorList& errors, QObject* parent);

    bool hasScene() const;  // on show, not behind the start page
    // Its scene is named from `folder`. Nothing on the start page, or if the scene is too large.
    std::optional<lessons::WindowState> now(const std::filesystem::path& folder = {}) const;
    void lookAt(const lessons::WindowState& state);     // the views; what cannot be shown is reported
    void showPlace(const lessons::WindowState& state);  // place and views, in the scene that is open
    void showBuffers(const std::vector<pipeline::BufferName>& buffers);
    // A state for a step of undo, to show again on undo; nothing if the window's state cannot be kept.
    StepLooks looksTo(const lessons::WindowState& next);

private:
    Document& m_document;
    ViewArea& m_views;
    const WindowLayout& m_layout;
    ErrorList& m_errors;
};

}  // namespace app
