#pragma once
#include "app/desktop/progress_line.h"

namespace app {

class WorkList;

// What takes long, with a button to cancel; then what has been stopped, with one to go on. Hidden while there is neither.
class WorkBar : public ProgressLine {
    Q_OBJECT
public:
    WorkBar(WorkList& work, QWidget* parent);

private:
    void showWork();

    WorkList& m_work;
};

}  // namespace app
