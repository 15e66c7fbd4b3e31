/** The validator's number of issues of each severity. */
export interface Verdict {
  errors: number;
  warnings: number;
  remarks: number;
}
