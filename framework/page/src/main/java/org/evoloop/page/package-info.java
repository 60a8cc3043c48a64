/**
 * The live page of a converter: a server on the HTTP server of the JDK, and a page without anything from elsewhere.
 *
 * <p>What the converter does comes in one direction: {@code Broadcast} listens to the converter while somebody looks,
 * one {@code Stream} a viewer tells it to the browser, {@code page.js} lights the states in the drawings of {@code
 * org.evoloop.page.drawing}. What a person does comes in the other: {@code Gate} asks who it is, {@code Controls}
 * performs it on the console.
 *
 * <p>It uses the console and what that uses.
 */
@NullMarked
package org.evoloop.page;

import org.jspecify.annotations.NullMarked;
