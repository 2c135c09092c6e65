/**
 * @file RunPython.h
 * @brief From the window's signals to isthmus_plugin.pipelines, the only place that defines the
 * actions.
 */
#ifndef isthmus_RunPython_h
#define isthmus_RunPython_h

#include <QString>

namespace isthmus
{

/// Runs `isthmus_plugin.pipelines.<call>` in ParaView's Python; exceptions are shown as messages.
/// Sources that it creates are marked as up to date, so that Apply is not highlighted.
void RunPipelines(const QString& call);

/// The text that `isthmus_plugin.pipelines.<call>` returns.
QString AskPipelines(const QString& call);

}

#endif
