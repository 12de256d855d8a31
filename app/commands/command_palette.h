#pragma once
#include <functional>
#include <vector>

#include "app/widgets/popover.h"

class QLabel;
class QLineEdit;
class QListWidget;

namespace app {

// One thing that can be done by its name.
struct PaletteEntry {
    QString name;    // "Go to pixel…"
    QString place;   // "Inspect"
    QString keys;    // "Ctrl+G"
    QString whyNot;  // why it cannot be done now, or empty
    std::function<void()> run;
    QString words = {};  // others that it is found by: "cosine"
};

// How well the typed letters match a name: 0 for no match, more for consecutive letters, words in any order, and
// beginnings of words; most for the whole name. Case does not matter.
int matchQuality(const QString& typed, const QString& name);
// Or its place: "theme" finds all that stands in View › Theme, after every name with all that was typed.
int matchQuality(const QString& typed, const PaletteEntry& entry);

// Finds an action, a buffer, a scene, a lesson or a setting by a part of its name. Enter runs, arrows move, Esc closes.
class CommandPalette : public Popover {
    Q_OBJECT
public:
    explicit CommandPalette(QWidget* window);

    void open(std::vector<PaletteEntry> commands);
    QSize sizeHint() const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void filter();
    void run();

    std::vector<PaletteEntry> m_commands;
    std::vector<std::size_t> m_shown;  // of m_commands, best first
    QLineEdit* m_field;
    QListWidget* m_list;
    QLabel *m_count, *m_none;
};

}  // namespace app
