package org.evoloop.check.temporal;

/**
 * A named property.
 *
 * <p>Threading: immutable.
 *
 * @param name as written, may be the text of the formula
 * @param line its line in the file, from 1
 * @since 0.1
 */
public record Property(String name, Formula formula, int line) {}
