/**
 * @file FileCalls.h
 * @brief What std::filesystem does not do with files; one source for each system. Functions return
 * an errno, 0 on success.
 */
#ifndef isthmus_FileCalls_h
#define isthmus_FileCalls_h

#include <string>

namespace isthmus
{

int ProcessNumber();

int CheckWritable(const std::string& path);

/// Makes an empty file; EEXIST if there is one.
int MakeNewFile(const std::string& path);

/// Makes the system write a closed file to its disk.
int FlushToDisk(const std::string& path);

/// Gives a file another name, in place of a file of that name.
int MoveFileTo(const std::string& path, const std::string& target);

}

#endif
