package org.evoloop.fleet.observe;

/**
 * Whether a program does its work now.
 *
 * @param isGood whether it does
 * @param detail its status, for people, in one line
 * @since 0.1
 */
public record Health(boolean isGood, String detail) {}
