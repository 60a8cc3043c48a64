package org.evoloop.xmi;

import java.util.List;

/** How one tool writes XMI. {@code toString} says which files it reads and how to make one. */
interface XmiDialect {

    /** Whether a document that begins like this is of this dialect. */
    boolean recognises(XmiHead head);

    /**
     * Every machine of the document, unchecked.
     *
     * @param stream at the first element after the head
     */
    List<XmiMachine> read(XmiStream stream);
}
