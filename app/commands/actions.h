#pragma once
#include <functional>
#include <map>
#include <vector>

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
    Figure,
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
    Drill,
    WrongPicture,
    RunCommand,
    Keys,
    Manual,
};

// One action in one row, which the feature that carries it out adds. Menus, the list of keys and the command palette are
// made from the rows, in the order of the ids.
struct ActionRow {
    ActionId id;
    const char* menu;  // "View", "View/Theme"
    const char* text;
    const char* keys;  // QKeySequence's portable text; several parted by "; "
    const char* tip;
    std::function<void()> run;
    std::function<QString()> whyNot = {};  // why it cannot run now; empty: it can
    std::function<bool()> isOn = {};       // of a switch, or of one of several choices
    std::function<QString()> name = {};    // in place of `text`, where that changes
    bool needsScene = true;                // on show; else it can run on the start page too
    bool startsGroup = false;              // a line above it in its menu
    bool inTalk = false;                   // its keys work while presenting too
    QWidget* within = nullptr;             // its keys work in this part alone; null: in the whole window
};

// The rows as Qt's actions, with their menus.
class Actions : public QObject {
    Q_OBJECT
public:
    // hasScene: whether one is on show. The keys work wherever the focus is in `window`.
    Actions(QWidget* window, std::function<bool()> hasScene);

    void add(ActionRow row);
    void addChoices(std::vector<ActionRow> rows);  // of which one at a time is on
    const std::map<ActionId, ActionRow>& rows() const { return m_rows; }
    QAction* operator[](ActionId id) const { return m_actions.at(id); }
    QString whyNot(ActionId id) const;  // empty: it can run now
    QList<QAction*> inTalk() const;

    // Fills the bar with the menus of all rows. Then a menu named "File" is found by menu("File").
    void fillMenus(QMenuBar& bar);
    QMenu* menu(const QString& path) const { return m_menus.value(path); }
    // Asks every row anew. A disabled action has the reason as its tool tip.
    void refresh();

signals:
    void menusFilled();

private:
    void update(const ActionRow& row);

    QWidget* m_window;
    std::function<bool()> m_hasScene;
    std::map<ActionId, ActionRow> m_rows;
    std::map<ActionId, QAction*> m_actions;
    QHash<QString, QMenu*> m_menus;
};

// "Ctrl+→ or F4": a sequence of keys as people read it.
QString keysText(const QAction& action);

}  // namespace app
