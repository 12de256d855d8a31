#pragma once
#include <QTreeWidget>

#include "app/document/export_plan.h"

namespace app {

// The buffers of a frame by stage, each with its size and a check mark, or with the reason why it
// is left out. A stage's own mark checks what it has; Space does the same to all rows that are selected.
class ExportList : public QTreeWidget {
    Q_OBJECT
public:
    explicit ExportList(QWidget* parent = nullptr);

    // What the user has checked or unchecked stays so; derived buffers are checked by hand.
    void setFrame(const pipeline::Frame& frame, const lessons::DerivedRecipe& recipe);
    void setScale(double scale);                                  // of the pixels, as the files will have them
    void chooseAll();                                             // what the frame has
    void choose(const std::vector<pipeline::BufferName>& names);  // these alone
    std::vector<pipeline::BufferName> chosen() const;
    bool isAllChosen() const;  // every buffer of the frame that is there, no other of it

signals:
    void chosenChanged();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Entry {
        ExportRow row;
        QTreeWidgetItem* item;
        bool isIn(const std::vector<pipeline::BufferName>& names) const;
        bool isThere() const { return row.whyNot.isEmpty(); }
        bool isChecked() const { return item->checkState(0) == Qt::Checked; }
    };
    void follow(QTreeWidgetItem* item);
    void checkStages();

    void showSize(const Entry& entry);

    std::vector<Entry> m_entries;
    double m_scale = 1;
    bool m_takesNew = true;  // what a later frame has beside
};

}  // namespace app
