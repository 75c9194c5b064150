// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_INPUT_LIST_HPP
#define GCPW_APPS_INPUT_LIST_HPP

#include <string>
#include <vector>

/** @brief The photographs that a command line names.

An argument is a file; a folder, which stands for the pictures in it; a pattern with * or ?, which stands for the files that fit it;
or @LIST, a text file with one such argument a line, blank lines and those with # apart, relative to the list's folder.
Folders and patterns give files in the order of their names, numbers by value: 2.jpg before 10.jpg. A file that is there is taken
as it is, whatever letters its name has.
@param arguments in the order of the command line
@return each file once, where it was first named
@throws FileTrouble for a folder without pictures, a pattern without files, a list that cannot be read */
std::vector<std::string> listPhotographs(const std::vector<std::string>& arguments);

/// Whether a comes before b in the order of names: numbers by value, letters whether small or capital.
bool comesBefore(const std::string& a, const std::string& b);

#endif
