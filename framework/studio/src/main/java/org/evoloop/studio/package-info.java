/**
 * The studio: a page in which models are drawn as text and pictures, checked, tried and given to running converters.
 *
 * <p>{@code Studio} serves the page behind the gate of a live page, and {@code Routes} answers its requests. A request
 * brings the texts that it is about, so nothing is kept between two of them but the files of the {@code Folder}. What
 * the models mean is said by an {@link org.evoloop.studio.Analysis}, which the program provides.
 */
@NullMarked
package org.evoloop.studio;

import org.jspecify.annotations.NullMarked;
