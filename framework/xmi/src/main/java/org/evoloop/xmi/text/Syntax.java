package org.evoloop.xmi.text;

/** The languages of state diagrams. They share most statements; what differs is decided here. */
enum Syntax {
    MERMAID("Mermaid") {
        @Override
        boolean isIdPart(char letter) {
            return !Character.isWhitespace(letter) && "-:{}[]<>\"';,#".indexOf(letter) < 0;
        }
    },
    PLANTUML("PlantUML") {
        @Override
        boolean isIdPart(char letter) {
            return Character.isLetterOrDigit(letter) || letter == '_' || Character.isSurrogate(letter);
        }
    };

    private final String label;

    Syntax(String label) {
        this.label = label;
    }

    /** Whether an id may contain the letter. */
    abstract boolean isIdPart(char letter);

    @Override
    public String toString() {
        return label;
    }
}
