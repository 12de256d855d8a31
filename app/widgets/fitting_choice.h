#pragma once
#include <QStringList>
#include <QWidget>

class QComboBox;

namespace app {

class Segmented;

// One of some choices: side by side, or as a list where there is no room for that.
class FittingChoice : public QWidget {
    Q_OBJECT
public:
    // listName: the object's name of the list.
    FittingChoice(const QStringList& choices, const QString& name, const QString& listName, QWidget* parent = nullptr);

    void setNarrow(bool isNarrow);
    void setCurrent(int choice);  // says nothing

signals:
    void chosen(int choice);  // by the user

private:
    Segmented* m_segmented;
    QComboBox* m_list;
};

}  // namespace app
