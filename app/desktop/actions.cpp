#include "app/desktop/actions.h"

#include <array>

#include <QActionGroup>
#include <QMenu>

namespace app {

std::span<const ActionRow> actionTable() {
    using A = ActionId;
    static constexpr auto kTable = std::to_array<ActionRow>({
        {A::Open, "File", "Open…", "Ctrl+O", "Open a scene file."},
        {A::ReadAgain, "File", "Reload", "F5", "Read the scene's file again; views, step and pixel stay."},
        {A::Save, "File", "Save scene", "Ctrl+S",
         "Write the scene to its file; ask for a name if the file holds more than this program writes."},
        {A::SaveAs, "File", "Save scene as…", "Ctrl+Shift+S", "Write the scene with all its settings as a TOML file."},
        {A::Export, "File", "Export buffers…", "Ctrl+E", "Write the buffers of this frame to a folder.", false, true},
        {A::SaveBuffer, "File", "Save this buffer…", "", "Write the buffer of the active view to a folder."},
        {A::Slide, "File", "Picture for a slide…", "Ctrl+F12; F12",
         "Save a view in any size, on a transparent ground; the file opens the scene again."},
        {A::Film, "File", "Step film…", "", "Write a buffer's build-up, step by step, as a GIF or as PNG files."},
        {A::Handout, "File", "Lesson as a handout…", "", "Write the open lesson as pages for a browser."},
        {A::CheckRenderer, "File", "Check my renderer…", "Ctrl+Shift+R",
         "Choose the folder that your own renderer has written: which of its stages is the first that is wrong?", false,
         true},
        {A::RestoreSession, "File", "Restore the session at start", "",
         "Begin with what the window showed when it was closed.", true, true},
        {A::Close, "File", "Close", "Ctrl+W", "Close the scene and show the start page.", false, true},
        {A::Quit, "File", "Quit", "Ctrl+Q", "Close the window."},

        {A::Undo, "Edit", "Undo", "Ctrl+Z", "Take the last change back."},
        {A::Redo, "Edit", "Redo", "Ctrl+Shift+Z; Ctrl+Y", "Make the change again."},
        {A::CopyState, "Edit", "Copy view and state", "Ctrl+C",
         "Copy scene, stage, step, pixel and how every view looks, as text that a window shows again.", false, true},
        {A::PasteState, "Edit", "Paste view and state", "Ctrl+V", "Show what a window has copied as text."},
        {A::CopyValue, "Edit", "Copy value", "Alt+C",
         "Copy the picked pixel's value in the buffer on show, with all its digits.", false, true},
        {A::CopyPicture, "Edit", "Copy picture", "", "Copy the buffer on show as a picture, a pixel each."},
        {A::CopyEquationText, "Edit", "Copy equation as text", "Ctrl+Shift+C", "Copy the picked pixel's equation."},
        {A::CopyEquationMarkdown, "Edit", "Copy equation as Markdown", "", "Copy it with its formulas between $$."},
        {A::CopyEquationLatex, "Edit", "Copy equation as LaTeX", "", "Copy it as an align* of amsmath."},
        {A::CopyEquationJson, "Edit", "Copy equation as JSON", "", "Copy its lines as text and LaTeX, for programs."},
        {A::KeepResult, "Edit", "Keep the result before", "Alt+K",
         "Keep what the picked pixel's intensity was before the last change, or drop it.", true},
        {A::Preferences, "Edit", "Preferences…", "Ctrl+,",
         "Theme, text size, how numbers are written, and where the program keeps its files.", false, true},

        {A::TwoBufferViews, "View", "Second buffer view", "Ctrl+Alt+V", "Show a second buffer below the first.", true},
        {A::SplitRight, "View/Views", "Split to the right", "Ctrl+Alt+R",
         "Give half of the active view to a new one at its right."},
        {A::SplitBelow, "View/Views", "Split below", "Ctrl+Alt+B",
         "Give half of the active view to a new one below it."},
        {A::TurnView, "View/Views", "Buffer or 3D view", "Ctrl+Alt+D",
         "Put a 3D view in place of the active buffer view, or a buffer view in place of the 3D view."},
        {A::CloseView, "View/Views", "Close the view", "Ctrl+Alt+W", "Give the active view's room to its neighbours."},
        {A::EvenViews, "View/Views", "Equal parts", "Ctrl+Alt+E", "Make the views in a row or column the same size."},
        {A::LinkViews, "View/Views", "Linked zoom", "Ctrl+L", "Buffer views of the same size zoom and move together.",
         true},
        {A::OriginalSize, "View/Views", "One to one", "Ctrl+0",
         "Show the active buffer view's picture a pixel of the screen each."},
        {A::NextView, "View/Views", "Next view", "Ctrl+Tab", "Go to the next view.", false, true},
        {A::PreviousView, "View/Views", "Previous view", "Ctrl+Shift+Tab", "Go to the view before."},
        {A::Thumbnails, "View", "Thumbnails", "Ctrl+T", "Show the buffers small, in the order of the stages.", true},
        {A::DarkTheme, "View/Theme", "Dark", "", "Light letters on a dark ground.", true, true},
        {A::LightTheme, "View/Theme", "Light", "", "Dark letters on a light ground.", true},
        {A::ProjectorTheme, "View/Theme", "Projector", "", "Black on white, larger.", true},
        {A::LargerText, "View", "Larger text",
         "Ctrl+Shift++; Ctrl+Shift+=", "Make everything but the pictures larger."},
        {A::SmallerText, "View", "Smaller text", "Ctrl+Shift+-; Ctrl+Shift+_",
         "Make everything but the pictures smaller."},
        {A::FullScreen, "View", "Full screen", "F11", "Fill the screen, or give it back.", true, true},
        {A::Present, "View", "Clean view", "Ctrl+F11",
         "Show the views alone on the whole screen, large; with cues, a talk."},
        {A::NotesScreen, "View", "Notes on second screen", "",
         "While presenting: notes, the next cue and the time on the other screen.", true},
        {A::LookLayout, "View/Layout", "Look", "Ctrl+Shift+1", "A buffer beside the 3D view.", false, true},
        {A::ExplainLayout, "View/Layout", "Explain", "Ctrl+Shift+2",
         "Two buffers one above the other, beside the 3D view, and the buffers small."},
        {A::CompareLayout, "View/Layout", "Compare", "Ctrl+Shift+3", "Two buffers side by side."},
        {A::FourLayout, "View/Layout", "Four views", "Ctrl+Shift+6",
         "Three buffers that explain the stage, and the 3D view, in two rows."},
        {A::SpaceLayout, "View/Layout", "3D view alone", "Ctrl+Shift+4", "The 3D view in the whole middle."},
        {A::PictureLayout, "View/Layout", "One buffer alone", "Ctrl+Shift+5", "A buffer in the whole middle."},
        {A::KeepLayout, "View/Layout", "Keep this layout…", "", "Keep panels and views as they are, under a name."},
        {A::ResetLayout, "View/Layout", "Reset", "", "Put all panels back in their places."},

        {A::NextStage, "Run", "Next stage", "Ctrl+Right", "Go to the stage after this one."},
        {A::PreviousStage, "Run", "Previous stage", "Ctrl+Left", "Go to the stage before this one."},
        {A::Play, "Run", "Play", "Space", "Play step after step, or stop.", true, true},
        {A::StepOn, "Run", "Step", "F10", "Make one step, as far as the timeline says."},
        {A::StepBack, "Run", "Step back", "Shift+F10", "Take one step back, exactly."},
        {A::RunToSelection, "Run", "Run to the selection", "Ctrl+F10",
         "Go on until something happens to the picked pixel, or to what is selected."},
        {A::StopWhere, "Run", "Stop where…", "Ctrl+Shift+F10",
         "Go on until a condition begins to hold at a pixel; ask for the condition first."},
        {A::FirstStep, "Run", "First step", "Home", "Go to before the first step: nothing has run."},
        {A::LastStep, "Run", "Whole frame", "End", "Go to the end of the frame."},
        {A::KeepCue, "Run", "Keep as a cue", "Ctrl+B", "Keep what you see as the next cue of a talk.", false, true},
        {A::NextCue, "Run", "Next cue", "PgDown", "Show the next cue, as a clicker does."},
        {A::PreviousCue, "Run", "Previous cue", "PgUp", "Show the cue before, exactly as it was."},
        {A::Bookmark, "Run", "Bookmark", "Ctrl+Shift+B", "Set a bookmark here, or remove it.", true, true},
        {A::Bookmark1, "Run/Bookmarks", "Bookmark 1", "Ctrl+1", "Go to the bookmark."},
        {A::Bookmark2, "Run/Bookmarks", "Bookmark 2", "Ctrl+2", "Go to the bookmark."},
        {A::Bookmark3, "Run/Bookmarks", "Bookmark 3", "Ctrl+3", "Go to the bookmark."},
        {A::Bookmark4, "Run/Bookmarks", "Bookmark 4", "Ctrl+4", "Go to the bookmark."},
        {A::Bookmark5, "Run/Bookmarks", "Bookmark 5", "Ctrl+5", "Go to the bookmark."},
        {A::Bookmark6, "Run/Bookmarks", "Bookmark 6", "Ctrl+6", "Go to the bookmark."},
        {A::Bookmark7, "Run/Bookmarks", "Bookmark 7", "Ctrl+7", "Go to the bookmark."},
        {A::Bookmark8, "Run/Bookmarks", "Bookmark 8", "Ctrl+8", "Go to the bookmark."},
        {A::Bookmark9, "Run/Bookmarks", "Bookmark 9", "Ctrl+9", "Go to the bookmark."},
        {A::Transform, "Run", "Transform", "Alt+1", "Show the vertices on the screen.", true, true},
        {A::Cull, "Run", "Cull", "Alt+2", "Show which polygons are kept.", true},
        {A::Normals, "Run", "Normals", "Alt+3", "Show which way the surface faces.", true},
        {A::ShadowBuffer, "Run", "Shadow buffer", "Alt+4", "Show the depth that a light sees.", true},
        {A::ZBuffer, "Run", "Z-buffer", "Alt+5", "Show the nearest depth at every pixel.", true},
        {A::Shading, "Run", "Shading", "Alt+6", "Show the frame buffer.", true},

        {A::GoToPixel, "Inspect", "Go to pixel…", "Ctrl+G", "Pick a pixel by its column and row."},
        {A::Unpick, "Inspect", "Clear selection", "Ctrl+Shift+G", "Clear the picked pixel."},
        {A::WorstPixel, "Inspect", "Next worst pixel", "Alt+W",
         "Pick the pixel at which your renderer differs most; again: the next one."},
        {A::Contracts, "Inspect", "Contracts", "K", "List what must hold of this stage's output, and whether it does."},
        {A::Condition, "Inspect", "Condition…", "Ctrl+/", "Ask a question of every pixel: n_dot_l.0 > 0.9 && x < 300."},
        {A::RedChannel, "Inspect", "Equation in red", "Alt+R", "Write the equation of the red part.", true, true},
        {A::GreenChannel, "Inspect", "Equation in green", "Alt+G", "Write the equation of the green part.", true},
        {A::BlueChannel, "Inspect", "Equation in blue", "Alt+B", "Write the equation of the blue part.", true},

        {A::Study, "Study", "Error against run time…", "Ctrl+Alt+S",
         "Vary settings and show how wrong the picture is, and how long it takes."},
        {A::Check, "Study", "Stiff and extreme cases…", "Ctrl+Alt+C",
         "Run the inputs on which a formula that looks right fails."},

        {A::WrongPicture, "Learn", "The wrong picture…", "Ctrl+Alt+G",
         "Find the error in a wrong picture: look at buffers and pixels, mark the first wrong stage, name the cause."},

        {A::RunCommand, "Help", "Run a command…", "Ctrl+Shift+P", "Find any action, buffer or scene by its name."},
        {A::Keys, "Help", "Keys", "H; ?", "List the keys."},
        {A::Manual, "Help", "Manual", "F1", "Open the manual at the page about the focused part."},
    });
    return kTable;
}

Actions::Actions(QWidget* window) : QObject(window), m_window(window) {
    for (const ActionRow& row : actionTable()) {
        auto* action = new QAction(tr(row.text), this);
        action->setShortcuts(QKeySequence::listFromString(row.keys));
        action->setToolTip(tr(row.tip));
        action->setCheckable(row.checkable);
        action->setMenuRole(QAction::NoRole);
        window->addAction(action);
        m_actions[row.id] = action;
    }
    // Of these one at a time is checked.
    const auto oneOf = [this](std::initializer_list<ActionId> ids) {
        auto* group = new QActionGroup(this);
        for (const ActionId id : ids) group->addAction(m_actions[id]);
    };
    using A = ActionId;
    oneOf({A::DarkTheme, A::LightTheme, A::ProjectorTheme});
    oneOf({A::Transform, A::Cull, A::Normals, A::ShadowBuffer, A::ZBuffer, A::Shading});
    oneOf({A::RedChannel, A::GreenChannel, A::BlueChannel});
}

void Actions::addMenus(QMenuBar& bar) {
    for (const ActionRow& row : actionTable()) {
        const QString path = row.menu;
        const qsizetype slash = path.indexOf('/');
        const QString top = path.left(slash);
        QMenu*& menu = m_menus[top];
        if (!menu) {
            // By its first letter with Alt; "Alt+R" is the equation in red.
            menu = bar.addMenu(top == "Run" ? tr("R&un") : '&' + tr(qPrintable(top)));
            menu->setToolTipsVisible(true);
        }
        QMenu* place = menu;
        if (row.startsGroup) menu->addSeparator();
        if (slash > 0) {
            QMenu*& sub = m_menus[path];
            if (!sub) sub = m_menus[top]->addMenu(tr(qPrintable(path.mid(slash + 1))));
            place = sub;
        }
        place->addAction(m_actions[row.id]);
    }
}

void Actions::setEnabled(ActionId id, bool enabled, const QString& whyNot) {
    QAction* action = m_actions[id];
    action->setEnabled(enabled);
    action->setProperty("whyNot", enabled ? QString() : whyNot);
    for (const ActionRow& row : actionTable())
        if (row.id == id) action->setToolTip(enabled ? tr(row.tip) : whyNot);
}

QString keysText(const QAction& action) {
    QStringList keys;
    for (const QKeySequence& one : action.shortcuts()) keys += one.toString(QKeySequence::PortableText);
    QString text = keys.join(Actions::tr(" or "));
    text.replace("Left", "←").replace("Right", "→");
    return text;
}

}  // namespace app
