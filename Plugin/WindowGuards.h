/**
 * @file WindowGuards.h
 * @brief Keeps faults of ParaView's own window, which buttons of the toolbar make more frequent,
 * from ending the program.
 */
#ifndef WindowGuards_h
#define WindowGuards_h

class QWidget;
class pqView;

namespace isthmus
{

/// ParaView's shortcut Escape, which ends the selection in a view, keeps a bare pointer to the
/// button that began it, also after the view with the button was deleted (by Reset Session, for
/// instance). Disables the shortcut then.
void GuardEscape(QWidget* window);

/// The view of a table repaints its widget after each rendering, also when the layout has already
/// deleted that. Such a view no longer repaints.
void GuardTable(pqView* view);

}

#endif
