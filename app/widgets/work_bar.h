#pragma once
#include "app/widgets/progress_line.h"

namespace app {

class WorkList;

// Long computations with a button to cancel, then the stopped ones with a button to continue. Hidden if there are none.
class WorkBar : public ProgressLine {
    Q_OBJECT
public:
    WorkBar(WorkList& work, QWidget* parent);

private:
    void showWork();

    WorkList& m_work;
};

}  // namespace app
