//! The document: commands, history, undo, project file.
