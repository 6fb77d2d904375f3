-- The table of the window is put into another order from indexes alone: none of the rows is read.
-- State and number tell which sherds are shown.
DROP INDEX sherd_number;
CREATE INDEX sherd_number ON sherd (number_sort, row, state, number);
CREATE INDEX sherd_state ON sherd (state);
CREATE INDEX sherd_part ON sherd (part);
CREATE INDEX sherd_ware ON sherd (ware);
