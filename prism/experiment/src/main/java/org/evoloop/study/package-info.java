/**
 * Runs the framework's converter against a simulated device whose times are random, and measures what the study's
 * models predict: losses, completion times, waiting times, and what crashes, links that break and other models change
 * in them.
 *
 * <p>This package may use all of the framework; it is used only by the study's programs, which call it as a process.
 */
@NullMarked
package org.evoloop.study;

import org.jspecify.annotations.NullMarked;
