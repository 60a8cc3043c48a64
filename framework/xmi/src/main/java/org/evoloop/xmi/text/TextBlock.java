package org.evoloop.xmi.text;

import java.util.List;

/**
 * The lines of one state diagram.
 *
 * @param title its author's name for it, or the heading above it; empty if there is none
 * @param line of its first line in the file, counted from 1
 * @param lines without the first one, which says what it is, and the last one, which ends it
 */
record TextBlock(String file, Syntax syntax, String title, int line, List<String> lines) {}
