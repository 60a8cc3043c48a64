package org.evoloop.xmi.dialect;

import java.util.List;
import org.evoloop.statemachine.ModelException;

/** One tool's way to write state machines. {@code toString} describes the files that it reads and how to make one. */
public interface XmiDialect {

    /** Whether a document that begins like this is of this dialect. */
    boolean recognises(XmiHead head);

    /**
     * Every machine of the document, in its order, unchecked.
     *
     * @param head what {@link XmiHead#read} has consumed
     * @param stream as {@link XmiHead#read} leaves it
     * @throws ModelException if the document as a whole cannot be read, see {@link XmiStream#refuse}
     */
    List<DrawnMachine> read(XmiHead head, XmiStream stream);
}
