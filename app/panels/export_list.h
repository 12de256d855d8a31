#pragma once
#include <QTreeWidget>

#include "app/core/export_plan.h"

namespace app {

// The buffers of a frame by stage, each with its size and a check mark, or with the reason why it
// is left out.
class ExportList : public QTreeWidget {
    Q_OBJECT
public:
    explicit ExportList(QWidget* parent = nullptr);

    // What the user has unchecked stays so; derived buffers are checked by hand.
    void setFrame(const pipeline::Frame& frame, const DerivedRecipe& recipe);
    std::vector<pipeline::BufferName> chosen() const;
    bool isAllChosen() const;  // every buffer of the frame that is there, no other of it

signals:
    void chosenChanged();

private:
    struct Entry {
        ExportRow row;
        QTreeWidgetItem* item;
    };
    std::vector<Entry> m_entries;
};

}  // namespace app
