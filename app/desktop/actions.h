#pragma once
#include <map>
#include <span>

#include <QAction>
#include <QMenuBar>
#include <QObject>

namespace app {

enum class ActionId : unsigned char {
    Open,
    ReadAgain,
    Save,
    SaveAs,
    Export,
    SaveBuffer,
    Slide,
    Film,
    Handout,
    CheckRenderer,
    RestoreSession,
    Close,
    Quit,
    Undo,
    Redo,
    CopyState,
    PasteState,
    CopyValue,
    CopyPicture,
    CopyEquationText,
    CopyEquationMarkdown,
    CopyEquationLatex,
    CopyEquationJson,
    KeepResult,
    Preferences,
    TwoBufferViews,
    SplitRight,
    SplitBelow,
    TurnView,
    CloseView,
    EvenViews,
    LinkViews,
    OriginalSize,
    NextView,
    PreviousView,
    Thumbnails,
    DarkTheme,
    LightTheme,
    ProjectorTheme,
    LargerText,
    SmallerText,
    FullScreen,
    Present,
    NotesScreen,
    LookLayout,
    ExplainLayout,
    CompareLayout,
    FourLayout,
    SpaceLayout,
    PictureLayout,
    KeepLayout,
    ResetLayout,
    NextStage,
    PreviousStage,
    Play,
    StepOn,
    StepBack,
    RunToSelection,
    StopWhere,
    FirstStep,
    LastStep,
    KeepCue,
    NextCue,
    PreviousCue,
    Bookmark,
    Bookmark1,
    Bookmark2,
    Bookmark3,
    Bookmark4,
    Bookmark5,
    Bookmark6,
    Bookmark7,
    Bookmark8,
    Bookmark9,
    Transform,
    Cull,
    Normals,
    ShadowBuffer,
    ZBuffer,
    Shading,
    GoToPixel,
    Unpick,
    WorstPixel,
    Contracts,
    Condition,
    RedChannel,
    GreenChannel,
    BlueChannel,
    Study,
    Check,
    WrongPicture,
    RunCommand,
    Keys,
    Manual,
};

// One action: its place in the menus, its key, and one line on what it does. Menus, the list of
// keys and the command palette are made from these rows.
struct ActionRow {
    ActionId id;
    const char* menu;  // "View", "View/Theme"
    const char* text;
    const char* keys;  // QKeySequence's portable text; several parted by "; "
    const char* tip;
    bool checkable = false;
    bool startsGroup = false;  // a line above it in its menu
};
std::span<const ActionRow> actionTable();

// The table's rows as Qt's actions, with their menus.
class Actions : public QObject {
    Q_OBJECT
public:
    // The keys work wherever the focus is in `window`.
    explicit Actions(QWidget* window);

    QAction* operator[](ActionId id) const { return m_actions.at(id); }
    // Fills the bar with the table's menus, in their order. A menu named "File" is found again by menu("File").
    void addMenus(QMenuBar& bar);
    QMenu* menu(const QString& path) const { return m_menus.value(path); }
    // Disabled actions say why.
    void setEnabled(ActionId id, bool enabled, const QString& whyNot = {});

private:
    QWidget* m_window;
    std::map<ActionId, QAction*> m_actions;
    QHash<QString, QMenu*> m_menus;
};

// "Ctrl+→ or F4": a sequence of keys as people read it.
QString keysText(const QAction& action);

}  // namespace app
