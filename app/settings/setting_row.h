#pragma once
#include <QWidget>
#include <functional>

#include "app/document/document.h"

class QGridLayout;
class QLabel;

namespace app {

// The control of one setting in a form of three columns: label; slider, buttons or list; number. It follows the
// document. A setting without effect in this scene is dimmed, and a note below gives the reason. Uses three rows of the
// form.
class SettingRow : public QObject {
    Q_OBJECT
public:
    SettingRow(Document& document, pipeline::SettingRef setting, QGridLayout& form, int row, QWidget* parent);

    int widthBeside() const;        // the room that label and controls need beside each other
    int widthStacked() const;       // with the label above
    void setStacked(bool stacked);  // the label on a line of its own, above
    bool isIdle() const { return !m_idle.isEmpty(); }
    void setShown(bool shown);

private:
    void place();
    void addNumber(QWidget* parent);
    void addChoice(QWidget* parent);
    void showScene();
    void showPointed();
    void change(double value, Document::Change kind);

    Document& m_document;
    pipeline::SettingRef m_setting;
    QGridLayout& m_form;
    int m_row;
    bool m_stacked = false;
    QLabel* m_label = nullptr;
    QLabel* m_note = nullptr;
    QString m_idle;
    bool m_shown = true;
    QList<QWidget*> m_controls;
    std::function<void(double value, std::optional<double> before)> m_show;
};

// "k_r red" as rich text: the symbol in the formulas' letters, the rest as it stands.
QString labelWithSymbol(const QString& label);
// The choice's name for people: "Flat", "Look-at", "At infinity", "Float".
QString choiceName(std::string_view choice);

}  // namespace app
