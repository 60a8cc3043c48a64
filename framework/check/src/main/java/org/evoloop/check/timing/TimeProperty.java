package org.evoloop.check.timing;

/**
 * A named time property.
 *
 * <p>Threading: immutable.
 *
 * @param name as written, may be the text of the property
 * @param line its line in the file, from 1
 * @since 0.1
 */
public record TimeProperty(String name, TimeForm form, int line) {}
