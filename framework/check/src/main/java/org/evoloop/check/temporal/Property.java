package org.evoloop.check.temporal;

/**
 * A property that its author has written down.
 *
 * <p>Threading: immutable.
 *
 * @param name as written, may be the text of the formula
 * @param line where it stands in its file, from 1
 * @since 0.1
 */
public record Property(String name, Formula formula, int line) {}
