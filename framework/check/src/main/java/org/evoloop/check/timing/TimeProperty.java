package org.evoloop.check.timing;

/**
 * A time property that its author has written down.
 *
 * <p>Threading: immutable.
 *
 * @param name as written, may be the text of the property
 * @param line where it stands in its file, from 1
 * @since 0.1
 */
public record TimeProperty(String name, TimeForm form, int line) {}
